// What every bench does with its result: a file in the folder, and a table or JSON to the user.
#pragma once

#include <iostream>

#include "app/command.h"
#include "jobs/write_results.h"

namespace plumb::app {

template <class Bench>
void Publish(const Bench& bench, const Common& common) {
    WriteBenchResults(common.out, bench);
    if (common.json) {
        std::cout << ToJsonText(bench);
    } else if (!common.quiet) {
        WriteTable(std::cout, bench);
    }
}

}  // namespace plumb::app
