// What a technique says of itself, as data: its paper, its knobs and its switches.
//
// A knob is a number, a whole number, or one of a few named choices; a switch is an approximation
// that can be turned off. All that is generic is written over these: --set NAME.KNOB=VALUE, scene
// files, lists, help, docs, sweeps, error budgets.
//
// Symbols  A value is a double whatever the kind: of a choice its place in the list, of a switch 0
//          (off) or 1 (on).
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

struct Knob {
    enum class Kind { kNumber, kWhole, kChoice, kSwitch };

    std::string name;  ///< As commands and files have it; a dimension is part of it: radius_m.
    std::string symbol = {};   ///< The paper's; may be empty.
    std::string unit = {};     ///< Empty = none.
    std::string meaning = {};  ///< One line.
    Kind kind = Kind::kNumber;
    double low = 0, high = 0;  ///< Its domain; of a number or whole number.
    bool low_is_out = false, high_is_out = false;
    std::vector<std::string> choices = {};  ///< Of a choice; off and on of a switch.
    double published = 0;                   ///< What runs if nothing is said.
    std::vector<std::string> covers = {};   ///< Knobs after it that it sets too.

    bool IsSwitch() const { return kind == Kind::kSwitch; }
};

struct Description {
    std::string name;         ///< Among all techniques.
    std::string family = {};  ///< Shared by those that differ in their published values alone.
    std::string paper = {};   ///< A key of docs/references.bib, or who made it.
    std::string what = {};    ///< One line.
    std::vector<Knob> knobs = {};  ///< And switches, in the order in which they are set.
};

/// Values of knobs by name, those alone that are given.
using KnobValues = std::map<std::string, double>;

/// "in [0, 1)", "a whole number in [1, 64]", "one of a, b".
std::string RuleOf(const Knob& knob);

bool Allows(const Knob& knob, double value);

/// "0.5", "spiral", "off": what ValueOfText reads back to the same bits.
std::string TextOf(const Knob& knob, double value);

/// Throws Error "WHERE = TEXT, must be ..." where it is no value of that knob.
double ValueOfText(const Knob& knob, const std::string& text, const std::string& where);

/// Throws Error, with all names and the nearest, if there is no such knob; `where` says who asks.
const Knob& KnobNamed(const Description& description, const std::string& name,
                      const std::string& where);

/// The value given, else the published one.
double ValueOf(const Description& description, const KnobValues& values,
               const std::string& name);

/// Those of `over` win, and what a knob of `over` covers loses what `under` says of it.
KnobValues Merged(const Description& description, KnobValues under, const KnobValues& over);

/// Texts by knob, as a file has them. `where` says which one; Throws Error as ValueOfText does.
KnobValues ValuesOfTexts(const Description& description,
                         const std::map<std::string, std::string>& texts,
                         const std::string& where);

}  // namespace plumb
