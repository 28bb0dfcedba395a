// Knobs that know where in a technique's options they turn: written once a technique, as a list.
//
//       Number<GtaoOptions>("falloff_start", "", "", {0, 1}, "Share of the radius ...",
//                           [](auto& o) -> auto& { return o.falloff_start; })
//
// The published value is read out of the published options, so that no number stands twice.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/description.h"
#include "core/error.h"
#include "techniques/technique.h"

namespace plumb {

template <class Options>
struct BoundKnob {
    Knob knob;  ///< Without a published value.
    std::function<double(const Options&)> get;
    std::function<void(Options&, double)> set;
};

template <class Options>
using BoundKnobs = std::vector<BoundKnob<Options>>;

struct Domain {
    double low = 0, high = 0;
    bool low_is_out = false, high_is_out = false;
};

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A knob that is one field: `field(options)` returns a reference to it.
template <class Options, class Field>
BoundKnob<Options> FieldKnob(Knob knob, Field field) {
    using Value = std::remove_cvref_t<decltype(field(std::declval<Options&>()))>;
    return {std::move(knob), [field](const Options& o) { return double(field(o)); },
            [field](Options& o, double value) {
                if constexpr (std::is_same_v<Value, bool>) {
                    field(o) = value != 0;
                } else if constexpr (std::is_enum_v<Value>) {
                    field(o) = Value(int(value));
                } else {
                    field(o) = Value(value);
                }
            }};
}

template <class Options, class Field>
BoundKnob<Options> Number(std::string name, std::string symbol, std::string unit, Domain domain,
                          std::string meaning, Field field) {
    return FieldKnob<Options>({.name = std::move(name),
                               .symbol = std::move(symbol),
                               .unit = std::move(unit),
                               .meaning = std::move(meaning),
                               .kind = Knob::Kind::kNumber,
                               .low = domain.low,
                               .high = domain.high,
                               .low_is_out = domain.low_is_out,
                               .high_is_out = domain.high_is_out,
                               .choices = {}},
                              field);
}

template <class Options, class Field>
BoundKnob<Options> Whole(std::string name, std::string symbol, std::string unit, Domain domain,
                         std::string meaning, Field field) {
    BoundKnob<Options> bound = Number<Options>(
        std::move(name), std::move(symbol), std::move(unit), domain, std::move(meaning), field);
    bound.knob.kind = Knob::Kind::kWhole;
    return bound;
}

/// Choices in the order of the enumerators.
template <class Options, class Field>
BoundKnob<Options> Choice(std::string name, std::vector<std::string> choices,
                          std::string meaning, Field field) {
    return FieldKnob<Options>({.name = std::move(name),
                               .symbol = {},
                               .unit = {},
                               .meaning = std::move(meaning),
                               .kind = Knob::Kind::kChoice,
                               .choices = std::move(choices)},
                              field);
}

inline Knob SwitchCalled(std::string name, std::string meaning) {
    return {.name = std::move(name),
            .symbol = {},
            .unit = {},
            .meaning = std::move(meaning),
            .kind = Knob::Kind::kSwitch,
            .choices = {"off", "on"}};
}

template <class Options, class Field>
BoundKnob<Options> Switch(std::string name, std::string meaning, Field field) {
    return FieldKnob<Options>(SwitchCalled(std::move(name), std::move(meaning)), field);
}

/// The knobs of a part, as knobs of the whole.
template <class Options, class Part, class Field>
BoundKnobs<Options> Within(const BoundKnobs<Part>& knobs, Field field) {
    BoundKnobs<Options> all;
    for (const BoundKnob<Part>& of : knobs) {
        all.push_back({of.knob, [of, field](const Options& o) { return of.get(field(o)); },
                       [of, field](Options& o, double value) { of.set(field(o), value); }});
    }
    return all;
}

template <class Options>
BoundKnobs<Options> Together(BoundKnobs<Options> all, const BoundKnobs<Options>& more) {
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

/// What a family of techniques does with its options.
template <class Options>
struct Behaviour {
    std::function<Falloff(const Options&)> falloff;
    std::function<int(const Options&)> samples;
    std::function<void(const Options&, const TechniqueInput&, const PassObserver&)> run;
};

/// One member of a family: its name and its published options. `about.knobs` is filled in.
template <class Options>
PictureTechnique MakeTechnique(Description about, const Options& published,
                               const BoundKnobs<Options>& knobs,
                               const Behaviour<Options>& behaviour) {
    for (const BoundKnob<Options>& bound : knobs) {
        about.knobs.push_back(bound.knob);
        about.knobs.back().published = bound.get(published);
    }
    return {about, [=](const KnobValues& values) {
                Options options = published;
                for (const auto& [name, value] : values) KnobNamed(about, name, "values");
                for (const BoundKnob<Options>& bound : knobs) {
                    const auto given = values.find(bound.knob.name);
                    if (given == values.end()) continue;
                    if (!Allows(bound.knob, given->second)) {
                        throw Error(MustBe(about.name + "." + given->first, given->second,
                                           RuleOf(bound.knob)));
                    }
                    bound.set(options, given->second);
                }
                return TurnedTechnique{
                    behaviour.falloff(options), behaviour.samples(options),
                    [options, run = behaviour.run](const TechniqueInput& in,
                                                   const PassObserver& observer) {
                        run(options, in, observer);
                    }};
            }};
}

}  // namespace plumb
