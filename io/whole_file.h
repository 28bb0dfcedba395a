// Output files that appear whole or not at all.
//
// The content goes to a file of its own beside the target, is flushed to the disk, and then
// takes the target's name in one step. A full disk, a failed write, an exception or an
// interruption that unwinds leaves the old target as it was and nothing beside it. Folders that
// are missing are made; a symbolic link is followed, not replaced.
//
// Beware   A process that is killed outright (SIGKILL, power) cannot tidy up: what may be left
//          then is a file with ".part" in its name, never half a target. A target that is a
//          device or a pipe (/dev/stdout) is written to directly.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace plumb {

/// Replaces `path` by `bytes`. Throws MachineError naming the path and what the system said.
void WriteWholeFile(const std::filesystem::path& path, std::string_view bytes);

/// All bytes of a regular file. Throws Error naming the file if it is missing, cannot be read or
/// is a folder, a pipe or a device.
std::string ReadWholeFile(const std::filesystem::path& path);

}  // namespace plumb
