// Given half a command line, bash completes it with what --help lists.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace {

// The words that bash would offer for the last of `words`, after the command's name.
std::string completed(const std::vector<std::string>& words) {
    std::string script = "source '" LACUNA_COMPLETION "'; COMP_WORDS=('" LACUNA_PROGRAM "'";
    for (const std::string& word : words) script += " '" + word + "'";
    script += "); COMP_CWORD=" + std::to_string(words.size());
    script += "; _lacuna; echo \"${COMPREPLY[*]}\"";
    const std::string command = "bash -c \"$(cat <<'END'\n" + script + "\nEND\n)\"";
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    std::string said;
    for (std::array<char, 256> part{}; std::fgets(part.data(), part.size(), pipe.get()) != nullptr;)
        said += part.data();
    if (!said.empty() && said.back() == '\n') said.pop_back();
    return said;
}

TEST(Completion, OffersCommands) {
    EXPECT_EQ(completed({"st"}), "stipple");
    EXPECT_EQ(completed({"re"}), "reproduce");
    const std::string all = completed({""});
    for (const char* command : {"sample", "verify", "analyze", "compare", "devices"})
        EXPECT_NE(all.find(command), std::string::npos) << command << " in: " << all;
}

TEST(Completion, OffersACommandsOptionsAndTheirValues) {
    EXPECT_EQ(completed({"sample", "--r"}), "--radius --round-size --report");
    EXPECT_EQ(completed({"stipple", "--metr"}), "--metric");
    EXPECT_EQ(completed({"stipple", "--metric", "m"}), "min mean max");
    EXPECT_EQ(completed({"sample", "--backend", "v"}), "vulkan");
    EXPECT_EQ(completed({"reproduce", "fig"}), "fig3 fig4 fig5 fig6 fig7 fig8");
}

}  // namespace
