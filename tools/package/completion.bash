# Completion of the options of Masu's tools, their values' names and gridbench's subcommands, all of which the tool
# itself lists with --help; otherwise of files.
_masu() {
  local tool=$1 word=$2 previous=$3 subcommand= help choices=
  if [[ ${tool##*/} == gridbench ]]; then
    if [[ $COMP_CWORD -eq 1 ]]; then
      choices=$("$tool" --help 2>/dev/null | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\+\).*/\1/p')
    elif [[ ${COMP_WORDS[1]} != -* ]]; then
      subcommand=${COMP_WORDS[1]}
    fi
  fi
  help=$("$tool" $subcommand --help 2>/dev/null)
  if [[ $previous == --* ]]; then # `  --store auto|float32|float64 …`
    choices=$(sed -n "s/^  \(-.,\)\?$previous \([^ =]*|[^ =]*\).*/\2/p" <<<"$help" | tr '|' ' ')
  elif [[ $word == -* ]]; then
    choices=$(sed -n 's/^  \(-.,\)\?\(--[a-z0-9-]*\).*/\2/p' <<<"$help")
  fi
  COMPREPLY=($(compgen -W "$choices" -- "$word"))
}
complete -o default -F _masu nffgen nff2bin mesh2bin gridbuild gridstat gridrender gridrender-mpi gridtrace gridtrace-mpi gridview gridbench
