#include "core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <numeric>
#include <set>
#include <thread>
#include <vector>

#include "core/error.h"
#include "core/program_monitor.h"
#include "core/random.h"

namespace plumb {
namespace {

// For what must come, however busy the machine is.
constexpr std::chrono::minutes kPatience(5);

class Parallel : public testing::Test {
  protected:
    ~Parallel() override { SetThreadCount(0); }
};

/// Numbers of very different size, summed in chunks: any other order gives other bits.
double SumByChunks(int threads) {
    SetThreadCount(threads);
    const std::int64_t n = 100'000, chunk_size = 777;
    std::vector<double> sums(std::size_t((n + chunk_size - 1) / chunk_size));
    ParallelFor(n, chunk_size, [&](std::int64_t begin, std::int64_t end) {
        double& sum = sums[std::size_t(begin / chunk_size)];
        for (std::int64_t i = begin; i < end; ++i) {
            sum += std::ldexp(RandomUnit(1, std::uint64_t(i), 0, 0), int(i % 60));
        }
    });
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

TEST_F(Parallel, SumsAreTheSameBitsOnAnyNumberOfThreads) {
    const double one = SumByChunks(1);
    EXPECT_EQ(SumByChunks(2), one);
    EXPECT_EQ(SumByChunks(5), one);
}

TEST_F(Parallel, VisitsEveryIndexOnceInChunksOfTheSizeGiven) {
    SetThreadCount(3);
    std::vector<int> visits(1000);
    std::mutex mutex;
    std::multiset<std::int64_t> sizes;
    ParallelFor(1000, 300, [&](std::int64_t begin, std::int64_t end) {
        EXPECT_EQ(begin % 300, 0);
        for (std::int64_t i = begin; i < end; ++i) ++visits[std::size_t(i)];
        const std::lock_guard lock(mutex);
        sizes.insert(end - begin);
    });
    EXPECT_EQ(visits, std::vector<int>(1000, 1));
    EXPECT_EQ(sizes, (std::multiset<std::int64_t>{100, 300, 300, 300}));
}

TEST_F(Parallel, RunsOnAsManyThreadsAsSet) {
    for (int threads : {1, 2, 5}) {
        SetThreadCount(threads);
        EXPECT_EQ(ThreadCount(), threads);
        // Each waits for all others: fewer threads would never get there.
        std::mutex mutex;
        std::condition_variable all_are_here;
        std::set<std::thread::id> seen;
        ParallelFor(threads, 1, [&](std::int64_t, std::int64_t) {
            std::unique_lock lock(mutex);
            seen.insert(std::this_thread::get_id());
            all_are_here.notify_all();
            EXPECT_TRUE(all_are_here.wait_for(lock, kPatience,
                                              [&] { return int(seen.size()) == threads; }));
        });
        EXPECT_EQ(int(seen.size()), threads);
        if (threads == 1) {
            EXPECT_EQ(seen, std::set{std::this_thread::get_id()});
        }
        ParallelFor(1000, 1, [&](std::int64_t, std::int64_t) {
            const std::lock_guard lock(mutex);
            seen.insert(std::this_thread::get_id());
        });
        EXPECT_LE(int(seen.size()), threads);
    }
}

TEST_F(Parallel, NothingToDoIsNoWork) {
    ParallelFor(0, 10, [](std::int64_t, std::int64_t) { FAIL(); });
}

TEST_F(Parallel, ThrowsWhatABodyThrows) {
    SetThreadCount(2);
    try {
        ParallelFor(100, 1, [](std::int64_t begin, std::int64_t) {
            if (begin == 42) throw Error("index 42");
        });
        FAIL() << "nothing thrown";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "index 42");
    }
}

TEST_F(Parallel, NoBodyRunsAfterTheExceptionIsOut) {
    SetThreadCount(2);
    // The second goes on for a while after the first has thrown, which it does not do alone.
    std::atomic<int> running = 0;
    std::atomic<bool> both = false, thrown = false;
    const auto wait = [](const std::atomic<bool>& event) {
        const auto end = std::chrono::steady_clock::now() + kPatience;
        while (!event && std::chrono::steady_clock::now() < end) std::this_thread::yield();
        EXPECT_TRUE(event);
    };
    EXPECT_THROW(ParallelFor(2, 1,
                             [&](std::int64_t begin, std::int64_t) {
                                 if (++running == 2) both = true;
                                 wait(both);
                                 if (begin == 0) {
                                     --running;
                                     thrown = true;
                                     throw Error("");
                                 }
                                 wait(thrown);
                                 for (int k = 0; k < 10000; ++k) std::this_thread::yield();
                                 --running;
                             }),
                 Error);
    EXPECT_EQ(running, 0);
}

class Recorder : public Monitor {
  public:
    explicit Recorder(int cancel_after = 1 << 30) : cancel_after_(cancel_after) {}
    void Progress(std::string_view stage, double done) override {
        const std::lock_guard lock(mutex_);
        stage_ = stage;
        seen_.push_back(done);
    }
    bool Cancelled() const override { return cancel_after_-- <= 0; }

    std::string stage_;
    std::vector<double> seen_;

  private:
    std::mutex mutex_;
    mutable std::atomic<int> cancel_after_;
};

TEST_F(Parallel, TellsTheMonitorAfterEachChunk) {
    SetThreadCount(1);
    Recorder recorder;
    ParallelFor(
        10, 3, [](std::int64_t, std::int64_t) {}, recorder, "links");
    EXPECT_EQ(recorder.stage_, "links");
    EXPECT_EQ(recorder.seen_, (std::vector<double>{0.25, 0.5, 0.75, 1}));
}

TEST_F(Parallel, CancelledThrowsInterruptedBetweenChunks) {
    for (int threads : {1, 2}) {
        SetThreadCount(threads);
        Recorder recorder(3);
        std::atomic<int> chunks = 0;
        EXPECT_THROW(ParallelFor(
                         100, 1, [&](std::int64_t, std::int64_t) { ++chunks; }, recorder),
                     Interrupted);
        EXPECT_EQ(chunks, 3);
    }
}

TEST_F(Parallel, LoopsMayNest) {
    SetThreadCount(2);
    std::atomic<int> inner = 0;
    ParallelFor(4, 1, [&](std::int64_t, std::int64_t) {
        ParallelFor(5, 1, [&](std::int64_t, std::int64_t) { ++inner; });
    });
    EXPECT_EQ(inner, 20);
}

// Law: loops that were handed no monitor hear the program's; those that write results do not.
TEST(ParallelFor, WithoutAMonitorHearsThePrograms) {
    struct Stop final : Monitor {
        void Progress(std::string_view, double) override {}
        bool Cancelled() const override { return true; }
    } stop;
    int calls = 0;
    const auto body = [&](std::int64_t, std::int64_t) { ++calls; };
    SetProgramMonitor(&stop);
    EXPECT_THROW(ParallelFor(3, 3, body), Interrupted);
    EXPECT_EQ(calls, 0);
    ParallelFor(3, 3, body, DeafMonitor());
    EXPECT_EQ(calls, 1);
    SetProgramMonitor(nullptr);
    ParallelFor(3, 3, body);
    EXPECT_EQ(calls, 2);
}

}  // namespace
}  // namespace plumb
