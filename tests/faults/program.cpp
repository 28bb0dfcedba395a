#include "tests/faults/program.h"

#include <fcntl.h>
#include <grp.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace plumb {
namespace fs = std::filesystem;
namespace {

constexpr uid_t kNobody = 65534;

double NowS() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

std::string Get(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void LookAgainSoon() {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

void Limit(__rlimit_resource_t resource, const std::optional<std::uint64_t>& most) {
    if (!most) return;
    const rlimit limit{.rlim_cur = *most, .rlim_max = *most};
    setrlimit(resource, &limit);
}

[[noreturn]] void Become(std::vector<char*> words, const Circumstances& with,
                         const fs::path& output, const fs::path& errors) {
    const auto lead = [](const fs::path& path, int stream) {
        const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
        if (file < 0 || dup2(file, stream) < 0) _exit(126);
    };
    lead(errors, STDERR_FILENO);
    lead(output, STDOUT_FILENO);
    if (!with.folder.empty() && chdir(with.folder.c_str()) != 0) _exit(126);
    const rlimit no_core{.rlim_cur = 0, .rlim_max = 0};
    setrlimit(RLIMIT_CORE, &no_core);
    Limit(RLIMIT_AS, with.memory_bytes);
    Limit(RLIMIT_FSIZE, with.file_bytes);
    if (with.as_nobody && IsRoot() &&
        (setgroups(0, nullptr) != 0 || setgid(kNobody) != 0 || setuid(kNobody) != 0)) {
        _exit(126);
    }
    execv(words[0], words.data());
    _exit(127);
}

}  // namespace

Program::Program(const std::vector<std::string>& arguments, const Circumstances& with)
    : begin_s_(NowS()) {
    static int serial = 0;
    const std::string part = (fs::temp_directory_path() / "plumb_faults_").string() +
                             std::to_string(getpid()) + "_" + std::to_string(++serial);
    output_ =
        with.standard_output.empty() ? fs::path(part + ".out") : fs::path(with.standard_output);
    errors_ = part + ".err";
    std::vector<std::string> texts = {PLUMB_PROGRAM};
    texts.insert(texts.end(), arguments.begin(), arguments.end());
    std::vector<char*> words;
    for (std::string& text : texts) words.push_back(text.data());
    words.push_back(nullptr);
    pid_ = fork();
    if (pid_ < 0) throw std::runtime_error("cannot start a process");
    if (pid_ == 0) Become(std::move(words), with, output_, errors_);
}

Program::~Program() {
    if (pid_ > 0) {
        kill(pid_, SIGKILL);
        waitpid(pid_, nullptr, 0);
    }
    std::error_code ignored;
    if (fs::is_regular_file(output_, ignored)) fs::remove(output_, ignored);
    fs::remove(errors_, ignored);
}

void Program::Send(int signal) const {
    if (pid_ <= 0) throw std::logic_error("it has ended: its number may be another's");
    kill(pid_, signal);
}

double Program::CpuS() const {
    // proc(5): after the name in brackets the 14th and 15th field are ticks of user and system.
    const std::string stat = Get("/proc/" + std::to_string(pid_) + "/stat");
    const std::size_t bracket = stat.rfind(')');
    if (bracket == std::string::npos) return 0;
    std::istringstream fields(stat.substr(bracket + 1));
    std::string skipped;
    for (int k = 3; k < 14; ++k) fields >> skipped;
    double user = 0, system = 0;
    fields >> user >> system;
    return (user + system) / double(sysconf(_SC_CLK_TCK));
}

bool Program::HasEnded() const {
    siginfo_t ended{};
    waitid(P_PID, id_t(pid_), &ended, WEXITED | WNOHANG | WNOWAIT);
    return ended.si_pid == pid_;
}

bool Program::HasAChild() const {
    const std::string pid = std::to_string(pid_);
    for (; !HasEnded(); LookAgainSoon()) {
        if (!Get("/proc/" + pid + "/task/" + pid + "/children").empty()) return true;
    }
    return false;
}

bool Program::IsAtWork(double cpu_s) const {
    for (std::optional<double> listens_since; true; LookAgainSoon()) {
        if (HasEnded()) return false;
        if (!listens_since) {
            // A line "SigCgt:" with the signals that are caught, bit SIGINT - 1 among them.
            const std::string status = Get("/proc/" + std::to_string(pid_) + "/status");
            const std::size_t at = status.find("SigCgt:");
            if (at == std::string::npos) continue;
            const std::uint64_t caught = std::strtoull(status.c_str() + at + 7, nullptr, 16);
            if (caught >> (SIGINT - 1) & 1) listens_since = CpuS();
        }
        if (listens_since && CpuS() >= *listens_since + cpu_s) return true;
    }
}

Ended Program::Wait(double patience_s) {
    Ended ended;
    int status = 0;
    rusage usage{};
    while (wait4(pid_, &status, WNOHANG, &usage) == 0) {
        if (NowS() > begin_s_ + patience_s && !ended.was_killed) {
            ended.was_killed = true;
            kill(pid_, SIGKILL);
        }
        LookAgainSoon();
    }
    pid_ = -1;
    ended.clock_s = NowS() - begin_s_;
    ended.cpu_s = double(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
                  1e-6 * double(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
    ended.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    std::error_code ignored;
    if (fs::is_regular_file(output_, ignored)) ended.output = Get(output_);
    ended.errors = Get(errors_);
    return ended;
}

Ended RunPlumb(const std::vector<std::string>& arguments, const Circumstances& with,
               double patience_s) {
    return Program(arguments, with).Wait(patience_s);
}

std::vector<std::string> Words(const std::string& line) {
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word == "''" ? "" : word);
    return words;
}

bool IsRoot() {
    return geteuid() == 0;
}

std::vector<std::string> PartsBelow(const fs::path& folder) {
    std::vector<std::string> parts;
    std::error_code error;
    for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end;
         it.increment(error)) {
        const std::string name = it->path().filename().string();
        if (name.find(".part") != std::string::npos) parts.push_back(name);
    }
    return parts;
}

}  // namespace plumb
