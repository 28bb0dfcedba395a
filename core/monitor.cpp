#include "core/monitor.h"

namespace plumb {
namespace {

class Silent final : public Monitor {
  public:
    void Progress(std::string_view, double) override {}
    bool Cancelled() const override { return false; }
};

}  // namespace

Monitor& SilentMonitor() {
    static Silent silent;
    return silent;
}

}  // namespace plumb
