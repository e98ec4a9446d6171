// Given half a command line, bash, zsh and fish complete it with what --help lists.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "expectations.h"
#include "program.h"
#include "required.h"

namespace {

using namespace lacuna::tests;

const std::string kFolder =
    std::string(LACUNA_PROGRAM).substr(0, std::string(LACUNA_PROGRAM).find_last_of('/'));

// A shell, and its script that prints the words that it offers, one a line. The arguments are the
// command line; its last word is half written.
struct Shell {
    std::string name;
    std::string script;
};

const Shell kBash{"bash", R"(source "$0"; COMP_WORDS=(lacuna "$@"); COMP_CWORD=$#; _lacuna
    printf '%s\n' "${COMPREPLY[@]}")"};

// Keeps the words that begin alike, as zsh does with the words that it gets.
const Shell kZsh{"zsh", R"(
    told() { print -rl -- ${(M)${@%%:*}:#$words[-1]*}; }
    compadd() { shift; told "$@"; }
    _describe() { [[ $1 == -o ]] && shift; told "${(P@)2}"; }
    _files() { print -r files; }
    source "$0"; words=(lacuna "$@"); CURRENT=$#words; _lacuna)"};

const Shell kFish{"fish", R"(source $argv[1]
    complete -C "lacuna $argv[2..-1]" | string replace -r '\t.*' '')"};

class Completion : public testing::TestWithParam<Shell> {
protected:
    void SetUp() override {
        Setting setting;
        setting.program = "/bin/sh";
        if (run({"-c", "command -v " + GetParam().name}, setting).exit_code == 0) return;
        if (is_required("shells")) FAIL() << "no " << GetParam().name;
        GTEST_SKIP() << "no " << GetParam().name << ": ./bootstrap.sh test installs it";
    }

    // The words that the shell would offer for the last of `words`, sorted.
    std::string completed(const Words& words) const {
        const Folder home;
        Setting setting;
        setting.program = "/usr/bin/env";
        setting.environment["PATH"] = kFolder + ":" + std::getenv("PATH");
        setting.environment["HOME"] = home.path("");
        Words arguments{GetParam().name};
        if (GetParam().name == "zsh") arguments.emplace_back("-f");
        arguments.insert(arguments.end(),
                         {"-c", GetParam().script, LACUNA_COMPLETION "." + GetParam().name});
        arguments.insert(arguments.end(), words.begin(), words.end());
        const Outcome outcome = run(arguments, setting);
        EXPECT_EQ(outcome.err, "");
        std::istringstream in(outcome.out);
        Words offered;
        for (std::string word; in >> word;) offered.push_back(word);
        std::sort(offered.begin(), offered.end());
        std::string all;
        for (const std::string& word : offered) all += (all.empty() ? "" : " ") + word;
        return all;
    }
};

TEST_P(Completion, OffersCommands) {
    EXPECT_EQ(completed({"st"}), "stipple");
    EXPECT_EQ(completed({"v"}), "verify version");
    EXPECT_EQ(completed({"re"}), "relax reproduce");
    const std::string all = completed({""});
    expect_has(all, {"sample", "verify", "analyze", "compare", "devices", "help"});
    EXPECT_EQ(completed({"help", "sa"}), "sample");
}

TEST_P(Completion, OffersACommandsOptionsAndTheirValues) {
    EXPECT_EQ(completed({"sample", "--r"}), "--radius --relax --report --round-size");
    EXPECT_EQ(completed({"stipple", "--metr"}), "--metric");
    EXPECT_EQ(completed({"stipple", "--metric", "m"}), "max mean min");
    EXPECT_EQ(completed({"stipple", "--mode", ""}), "cells exact stratified");
    EXPECT_EQ(completed({"stipple", "--start", "s"}), "stratified");
    EXPECT_EQ(completed({"sample", "--mode", ""}), "exact lines stratified");
    EXPECT_EQ(completed({"compare", "--mode", ""}), "cells exact lines stratified");
    EXPECT_EQ(completed({"stipple", "a.png", "--paper-size", "l"}), "legal letter");
    EXPECT_EQ(completed({"sample", "--format", "p"}), "pdf ply png");
    EXPECT_EQ(completed({"sample", "--backend", "v"}), "vulkan");
    EXPECT_EQ(completed({"reproduce", "fig"}), "fig3 fig4 fig5 fig6 fig7 fig8");
}

std::string name_of(const testing::TestParamInfo<Shell>& info) {
    return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(In, Completion, testing::Values(kBash, kZsh, kFish), name_of);

}  // namespace
