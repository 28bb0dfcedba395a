#include "app/command.h"

#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <map>
#include <mutex>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "core/program_monitor.h"
#include "core/time_in_turns.h"

namespace plumb::app {
namespace {

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

// The first Ctrl-C asks the run to end and tidy up; a second one ends it at once.
void OnInterrupt(int signal) {
    interrupted = true;
    std::signal(signal, SIG_DFL);
}

double NowS() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

class TerminalMonitor : public Monitor {
  public:
    explicit TerminalMonitor(bool draw) : draw_(draw) {
        std::signal(SIGINT, OnInterrupt);
        std::signal(SIGTERM, OnInterrupt);
        SetProgramMonitor(this);
    }
    ~TerminalMonitor() override {
        SetProgramMonitor(nullptr);
        Clear();
    }

    void Progress(std::string_view stage, double done) override {
        if (!draw_) return;
        const std::lock_guard lock(mutex_);
        const double now_s = NowS();
        if (stage != stage_ || done < done_) {
            stage_ = stage;
            begin_s_ = now_s;
            drawn_s_ = 0;
        }
        done_ = done;
        if (now_s - drawn_s_ < 0.1) return;
        drawn_s_ = now_s;
        const double left_s = done > 0 ? (now_s - begin_s_) * (1 - done) / done : 0;
        std::fprintf(stderr, "\r\033[K%s %3.0f %%", stage_.c_str(), 100 * done);
        if (now_s - begin_s_ > 2 && done > 0) std::fprintf(stderr, ", %.0f s left", left_s);
        std::fflush(stderr);
        shown_ = true;
    }

    bool Cancelled() const override { return interrupted; }

  private:
    void Clear() const {
        if (shown_) std::fprintf(stderr, "\r\033[K");
    }

    bool draw_, shown_ = false;
    std::mutex mutex_;
    std::string stage_;
    double begin_s_ = 0, drawn_s_ = 0, done_ = 0;
};

// Before hours of work, not after them: a folder that nothing can be written to. Makes nothing.
void CheckOut(const std::filesystem::path& out) {
    if (out.empty()) throw Error("--out is empty, must name a folder");
    std::error_code error;
    std::filesystem::path there = std::filesystem::absolute(out, error);
    // The first of the path that is there: the rest is made when there are results.
    struct stat found {};
    while (stat(there.c_str(), &found) != 0) {
        if (errno != ENOENT || !there.has_relative_path()) {
            throw MachineError("--out " + out.string() + ": " + std::strerror(errno));
        }
        there = there.parent_path();
    }
    if (!S_ISDIR(found.st_mode)) {
        throw MachineError("--out " + out.string() + ": " + there.string() + " is no folder");
    }
    if (access(there.c_str(), W_OK | X_OK) != 0) {
        throw MachineError("--out " + out.string() + ": " + there.string() + ": " +
                           std::strerror(errno));
    }
}

std::string& TheCommandLine() {
    static std::string text;
    return text;
}

/// CLI11 reads an unsigned number as strtoull does: -1 becomes 2^64 - 1, 2^64 the same.
std::string CheckSeed(const std::string& text) {
    std::uint64_t seed = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
    return error == std::errc() && end == text.data() + text.size()
               ? std::string()
               : "--seed = " + text + ", must be a whole number in [0, 2^64 - 1]";
}

using Group = std::multimap<int, void (*)(CLI::App&)>;

// Made at its first use: objects that list themselves are made before main().
std::map<std::string, Group>& Groups() {
    static std::map<std::string, Group> groups;
    return groups;
}

}  // namespace

void AddCommon(CLI::App& command, Common& common) {
    command.add_option("-o,--out", common.out, "Folder for all results; made if it is missing")
        ->capture_default_str();
    command
        .add_option("--threads", common.threads,
                    "Threads, 0 = all cores; no result depends on it")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    command
        .add_option("--seed", common.seed,
                    "Seed of all random numbers, a whole number in [0, 2^64 - 1]")
        ->check(CLI::Validator(CheckSeed, ""))
        ->capture_default_str();
    command.add_flag("-q,--quiet", common.quiet, "No progress, no table");
    command.add_flag("--json", common.json, "The report as JSON on standard output, no table");
}

void AddRounds(CLI::App& command, int& rounds) {
    command
        .add_option("--rounds", rounds,
                    "Rounds of every timing, after one that warms up; medians count")
        ->check(CLI::Range(kTimedRounds, 1000))
        ->capture_default_str();
}

CLI::Validator AboveZero() {
    return CLI::Validator(
        [](const std::string& text) {
            double value = 0;
            const bool read = CLI::detail::lexical_cast(text, value);
            return read && value > 0 && std::isfinite(value)
                       ? std::string()
                       : text + ", must be finite and > 0";
        },
        "");
}

std::unique_ptr<Monitor> MakeMonitor(const Common& common) {
    CheckOut(common.out);
    SetThreadCount(common.threads);
    return std::make_unique<TerminalMonitor>(!common.quiet && isatty(STDERR_FILENO));
}

std::string CommandLine() {
    return TheCommandLine();
}

void RememberCommandLine(int argc, char** argv) {
    const std::vector<std::string> with_value = {"-o", "--out", "--threads", "--cache"};
    const std::vector<std::string> flags = {"-q", "--quiet", "--json", "--resume",
                                            "--no-cache"};
    const auto is = [](const std::string& word, const std::vector<std::string>& list) {
        for (const std::string& option : list) {
            if (word == option) return true;
        }
        return false;
    };
    std::string& text = TheCommandLine();
    text = "plumb";
    for (int k = 1; k < argc; ++k) {
        std::string word = argv[k];
        if (is(word, flags)) continue;
        if (is(word, with_value)) {
            ++k;
            continue;
        }
        if (word.starts_with("--out=") || word.starts_with("--threads=") ||
            word.starts_with("--cache="))
            continue;
        // A path is named by its last part: no folder of the machine gets into a report.
        if (word.find('/') != std::string::npos && word[0] != '-') {
            word = std::filesystem::path(word).filename().string();
        }
        text += " " + word;
    }
}

RunContext ContextOf(const Common& common, Monitor& monitor) {
    return {.version = PLUMB_VERSION,
            .command = CommandLine(),
            .seed = common.seed,
            .clock = NowS,
            .monitor = monitor,
            .folder = common.out};
}

void Publish(const doc::Document& document, const Common& common) {
    Print(document, WriteDocument(common.out, document), common);
}

void Print(const doc::Document& document, const std::filesystem::path& page,
           const Common& common) {
    if (common.json) {
        std::cout << doc::ToJsonText(document);
    } else if (!common.quiet) {
        std::cout << doc::ToTerminal(document) << "\nReport: " << page.string() << "\n";
    }
}

Listed::Listed(std::string group, int place, void (*add)(CLI::App& parent)) {
    Groups()[std::move(group)].emplace(place, add);
}

void AddListed(CLI::App& parent, const std::string& group) {
    for (const auto& [place, add] : Groups()[group]) add(parent);
}

}  // namespace plumb::app
