#include "tools/view/turns.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace masu {
namespace {

const std::function<bool()> stays = [] { return false; };

// A turn that is taken until let_go(), on a thread of its own.
class Holder {
public:
  explicit Holder(Turns& turns)
      : thread_([this, &turns] {
          turns.run(stays, [this] {
            holds_ = true;
            holds_.notify_all();
            let_go_.wait(false);
          });
        }) {
    holds_.wait(false);
  }
  void let_go() {
    let_go_ = true;
    let_go_.notify_all();
  }

private:
  std::atomic<bool> holds_ = false, let_go_ = false;
  std::jthread thread_;
};

void wait_for_number_waiting(const Turns& turns, std::size_t number) {
  while (turns.waiting() != number)
    std::this_thread::yield();
}

TEST(Turns, ComeInOrder) {
  Turns turns(16);
  Holder holder(turns);
  std::vector<int> order;
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 10; ++i) {
      threads.emplace_back([&, i] { turns.run(stays, [&] { order.push_back(i); }); });
      wait_for_number_waiting(turns, static_cast<std::size_t>(i) + 1);
    }
    holder.let_go();
  }
  EXPECT_EQ(order, (std::vector{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

TEST(Turns, AreRefusedBeyondTheMostThatWait) {
  Turns turns(2);
  Holder holder(turns);
  std::jthread waiting([&] { turns.run(stays, [] {}); });
  wait_for_number_waiting(turns, 1);
  EXPECT_THROW(turns.run(stays, [] {}), Abandoned);
  holder.let_go();
}

TEST(Turns, OfThoseWhoHaveHungUpAreGivenToThoseWhoCome) {
  Turns turns(4);
  Holder holder(turns);
  std::atomic<bool> gone = false;
  std::atomic<int> abandoned = 0;
  const std::function<bool()> hangs_up = [&] { return gone.load(); };
  std::vector<std::jthread> threads;
  for (int i = 0; i < 3; ++i)
    threads.emplace_back([&] {
      EXPECT_THROW(turns.run(hangs_up, [] {}), Abandoned);
      ++abandoned;
    });
  wait_for_number_waiting(turns, 3);
  gone = true;
  bool ran = false;
  threads.emplace_back([&] { turns.run(stays, [&] { ran = true; }); });
  while (abandoned != 3)
    std::this_thread::yield();
  holder.let_go();
  threads.clear();
  EXPECT_TRUE(ran);
}

TEST(Turns, AreLeftByThoseWhoHangUpWhileTheyWait) {
  Turns turns(4);
  Holder holder(turns);
  std::atomic<bool> gone = false;
  std::jthread waiting([&] { EXPECT_THROW(turns.run([&] { return gone.load(); }, [] {}), Abandoned); });
  wait_for_number_waiting(turns, 1);
  gone = true;
  wait_for_number_waiting(turns, 0);
  holder.let_go();
}

TEST(Turns, PassOnWhereWorkThrows) {
  Turns turns(4);
  EXPECT_THROW(turns.run(stays, []() -> int { throw 1; }), int);
  EXPECT_EQ(turns.run(stays, [] { return 2; }), 2);
}

} // namespace
} // namespace masu
