// What can go wrong that is not our own mistake, one type a cause, caught once in main().
//
// Our own mistakes are assertions; a normal outcome (a fit that did not converge, a ray that
// met nothing) is a value, never an exception.
#pragma once

#include <stdexcept>
#include <string>

namespace plumb {

/// Bad input or usage. The message names file, field, value and rule, as in
/// "sponza.json: cameras[0].fov_deg = 190, must be in (0, 180)". Exit status 2.
class Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The machine failed us: a full disk, not enough memory. Exit status 3.
class MachineError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The user interrupted a run. Exit status 130.
class Interrupted : public std::runtime_error {
  public:
    Interrupted() : std::runtime_error("interrupted") {}
};

/// "SaoParams::radius_m = -1, must be > 0": the one form of a message about a value.
std::string MustBe(const std::string& thing, double value, const std::string& rule);

}  // namespace plumb
