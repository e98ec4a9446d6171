// CLI11's types by name alone: its header takes the compiler two seconds, and a file that only
// passes a command on does without it.
#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): not ours to name
class App;
class Option;
}  // namespace CLI
