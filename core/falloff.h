// How much less a technique counts what is farther away.
//
// A name for it that the judge and the judged share; what each means is in truth/near_visibility.h.
#pragma once

namespace plumb {

enum class Falloff { kHard, kLinear, kSao, kQuadratic, kFarEnd };

}  // namespace plumb
