// How steep a height map is: the share of its facets steeper than some angles.
#pragma once

#include "heightfield/height_field.h"
#include "reports/document.h"

namespace plumb {

doc::Section StudySlopes(const HeightField& field);

}  // namespace plumb
