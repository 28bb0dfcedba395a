#include "io/sanitizer_blame.h"

#ifdef __SANITIZE_ADDRESS__

#include <dlfcn.h>
#include <unistd.h>
#include <unwind.h>

#include <initializer_list>
#include <string_view>

namespace plumb {
namespace {

int library_status = 0;  // 0 = whose fault it is does not matter.

bool IsRuntime(std::string_view path) {
    const std::string_view name = path.substr(path.rfind('/') + 1);
    for (const std::string_view runtime :
         {"libasan.", "libubsan.", "libc.", "libstdc++.", "libgcc_s.", "libm."}) {
        if (name.starts_with(runtime)) return true;
    }
    return false;
}

// Frames from the innermost on: this file's, the sanitizer's, then whoever it speaks of.
struct Blame {
    void* own_base;
    bool beyond_own = false, library = false;
};

_Unwind_Reason_Code Look(_Unwind_Context* context, void* into) {
    Blame& blame = *static_cast<Blame*>(into);
    // The call, not where it returns to: that can be another function.
    auto* const call = reinterpret_cast<void*>(_Unwind_GetIP(context) - 1);
    Dl_info frame{};
    if (dladdr(call, &frame) == 0 || frame.dli_fname == nullptr) return _URC_NO_REASON;
    const bool is_own = frame.dli_fbase == blame.own_base;
    if (!is_own && IsRuntime(frame.dli_fname)) {
        blame.beyond_own = true;
        return _URC_NO_REASON;
    }
    if (is_own && !blame.beyond_own) return _URC_NO_REASON;
    blame.library = !is_own;
    return _URC_END_OF_STACK;
}

bool LibraryIsToBlame() {
    Dl_info own{};
    if (dladdr(reinterpret_cast<void*>(&EndAtReportsOfLibrariesWith), &own) == 0) return false;
    Blame blame{own.dli_fbase};
    // Not backtrace(): the sanitizer replaces it by one that needs frame pointers.
    _Unwind_Backtrace(&Look, &blame);
    return blame.library;
}

}  // namespace

void EndAtReportsOfLibrariesWith(int status) {
    library_status = status;
}

}  // namespace plumb

extern "C" void __asan_on_error() {
    if (plumb::library_status != 0 && plumb::LibraryIsToBlame()) _exit(plumb::library_status);
}

extern "C" const char* __asan_default_options() {
    // Memory that is not there is bad_alloc, as without the sanitizer.
    return "exitcode=66:allocator_may_return_null=1";
}
extern "C" const char* __ubsan_default_options() {
    return "exitcode=66";
}

#else

namespace plumb {

void EndAtReportsOfLibrariesWith(int) {}

}  // namespace plumb

#endif
