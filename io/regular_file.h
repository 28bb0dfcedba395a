// Files to read: only regular ones, and never a wait for one.
//
// A pipe makes a reader wait for ever, /dev/zero never ends, a folder reads as nothing. They are
// told apart before they are opened. What a name leads to is asked without exceptions, so
// that permission, loops of links and names that are too long end in the words of the system.
#pragma once

#include <cstdint>
#include <filesystem>

namespace plumb {

/// Whether something has this name. A name that nothing can have, because it is too long or
/// goes on below a file, has nothing. Throws Error if the system does not tell: no permission,
/// a loop of links.
bool IsThere(const std::filesystem::path& path);

/// Bytes of a regular file. Throws Error naming the file and why it cannot be read: missing, no
/// permission, a folder, a pipe, a device ...
std::uintmax_t RegularFileSize(const std::filesystem::path& path);

/// A descriptor open for reading on a regular file, for its caller to close. Throws as above.
int OpenRegularFile(const std::filesystem::path& path);

}  // namespace plumb
