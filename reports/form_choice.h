// Which form of the total wins on one half of the maps, and how every form does on the other.
//
// A form that is chosen and scored on the same maps looks better than it is: of many forms one
// wins by luck. Here the maps given first, third, fifth ... choose: each of them is held out in
// its turn, and the form with the least error wins. The maps given second, fourth ... report: the
// constants are fitted to the choosing half, and neither form nor constants have seen them.
//
// Beware   Both figures are of few maps; forms whose errors differ by less than maps do are not
//          told apart.
#pragma once

#include <string>
#include <vector>

namespace plumb {

struct FormScore {
    std::string form;          ///< Model::name.
    int constants = 0;         ///< Fitted; 0 = none, and nothing to hold out.
    double choosing_rms = 0;   ///< Of E(rho), each choosing map held out in its turn.
    double reporting_rms = 0;  ///< Of E(rho), on the reporting maps.
};

struct FormChoice {
    std::vector<std::string> choosing, reporting;  ///< Names of the maps.
    std::vector<FormScore> forms;                  ///< At least one, in the order tried.

    /// The least error on the choosing half; the first of equals.
    const FormScore& Winner() const;

    /// How many forms have less error on the reporting half, plus one.
    int RankOnReporting(const FormScore& score) const;
};

}  // namespace plumb
