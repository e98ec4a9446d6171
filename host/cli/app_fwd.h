// Declares CLI11's types. Its header takes two seconds to compile, and files that only pass a
// command on need no more than these names.
#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
class Option;
}  // namespace CLI
