// What techniques say of themselves, as text: for a terminal, as JSON, and as a page of the docs.
#pragma once

#include <span>
#include <string>

#include "core/description.h"

namespace plumb {

/// A line a technique: name and what it is.
std::string ListText(std::span<const Description> techniques);

/// One technique with its knobs and switches.
std::string DescriptionText(const Description& technique);

/// {"format": "plumb techniques 1", "techniques": [{"name", "family", "paper", "what", "knobs": [...],
/// "switches": [...]}]}. A knob has name, symbol, unit, kind, its domain or choices, published,
/// meaning.
std::string DescriptionsJson(std::span<const Description> techniques);

/// Tables of Markdown: one a family, with a column of published values for each of its members.
std::string DescriptionsMarkdown(std::span<const Description> techniques);

}  // namespace plumb
