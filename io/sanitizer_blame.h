// Whose fault a report of the address sanitizer is: ours or a library's.
//
// The system's libraries are not built with the sanitizer, but it sees what they ask of memcpy()
// or of new: a damaged file that makes assimp copy beyond its memory gives a report, where
// without the sanitizer it would crash or go on. That is damage of the file. A report about a
// line of this program is a fault of the program, whatever the file.
//
// Method   When the sanitizer has written its report it calls __asan_on_error(). Of the frames
//          of the stack the innermost decides that is neither of the sanitizer nor of the C and
//          C++ libraries.
// Source   AddressSanitizer's public interface, sanitizer/asan_interface.h.
// Beware   Templates and inline functions belong to who compiled them, also a library's.
#pragma once

namespace plumb {

/// From now on a report about a library ends this process with this status, in place of the
/// sanitizer's. Without the address sanitizer nothing happens.
void EndAtReportsOfLibrariesWith(int status);

}  // namespace plumb
