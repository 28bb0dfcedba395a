// Whether a piece of work ends by itself, tried in a process of its own.
//
// Readers of other people's formats crash: of assimp 5.2 those of PLY, OFF, 3MF and others do on
// damaged files, by a failed assertion or a bad pointer, where no exception can be caught. What
// survives in the child is then done again in the parent, from the same memory, to the same end.
//
// Cost     the work twice over.
#pragma once

#include <functional>

namespace plumb {

/// True if `work` returned or threw in a child process; false if it crashed there. Also true if
/// there can be no child. What the child prints is dropped.
bool Survives(const std::function<void()>& work);

}  // namespace plumb
