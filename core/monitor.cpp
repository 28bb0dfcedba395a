#include "core/monitor.h"

#include <atomic>

#include "core/program_monitor.h"

namespace plumb {
namespace {

std::atomic<const Monitor*> program_monitor = nullptr;

class Silent final : public Monitor {
  public:
    void Progress(std::string_view, double) override {}
    bool Cancelled() const override {
        const Monitor* program = program_monitor;
        return program != nullptr && program->Cancelled();
    }
};

class Deaf final : public Monitor {
  public:
    void Progress(std::string_view, double) override {}
    bool Cancelled() const override { return false; }
};

}  // namespace

Monitor& SilentMonitor() {
    static Silent silent;
    return silent;
}

void SetProgramMonitor(const Monitor* monitor) {
    program_monitor = monitor;
}

Monitor& DeafMonitor() {
    static Deaf deaf;
    return deaf;
}

}  // namespace plumb
