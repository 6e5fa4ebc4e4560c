# How .ci/run builds, in three quarters of the time: libraries optimized less than users run them, which must give the same
# bits, and kernels, where there is no GPU, as far as to PTX: to be compiled for what is wrong with them, not to be run.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "" FORCE)
execute_process(COMMAND nvidia-smi -L OUTPUT_VARIABLE gpus ERROR_QUIET)
if(NOT gpus MATCHES GPU)
  set(MASU_CUDA_ARCHITECTURES 90-virtual CACHE STRING "" FORCE)
  set(flags "-O0 -DNDEBUG")
  find_program(nvcc nvcc HINTS /usr/local/cuda/bin NO_CACHE)
  execute_process(COMMAND ${nvcc} --help OUTPUT_VARIABLE help ERROR_QUIET)
  if(help MATCHES "--Ofast-compile")
    string(APPEND flags " --Ofast-compile=max")
  endif()
  set(CMAKE_CUDA_FLAGS_RELEASE "${flags}" CACHE STRING "" FORCE)
endif()
