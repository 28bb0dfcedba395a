// A folder of its own for every test case, gone afterwards, and what errors say.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

namespace plumb {

class TempFolder : public testing::Test {
  protected:
    TempFolder() {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        std::string name = info->name();
        std::replace(name.begin(), name.end(), '/', '_');  // "Case/3" of a table of cases.
        folder_ = std::filesystem::temp_directory_path() /
                  ("plumb_io_" + std::to_string(getpid()) + "_" + name);
        std::filesystem::create_directories(folder_);
    }
    ~TempFolder() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path Path(const std::string& name) const { return folder_ / name; }

    /// Puts `content` into a file of the folder without help of what is tested.
    std::filesystem::path Put(const std::string& name, const std::string& content) const {
        std::ofstream(Path(name), std::ios::binary) << content;
        return Path(name);
    }

    std::string Get(const std::string& name) const {
        std::ifstream file(Path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    int FileCount() const {
        int count = 0;
        for ([[maybe_unused]] const auto& entry :
             std::filesystem::directory_iterator(folder_)) {
            ++count;
        }
        return count;
    }

    std::filesystem::path folder_;
};

/// What the error of type E says; a failure if `call` throws none.
template <class E, class Call>
std::string MessageOf(const Call& call) {
    try {
        call();
    } catch (const E& error) {
        return error.what();
    }
    ADD_FAILURE() << "nothing thrown";
    return {};
}

}  // namespace plumb
