// Writes files, then streams.
#include "cli/reports/writing.h"

#include <utility>

#include "cli/reports/output.h"
#include "files/point_files.h"

namespace lacuna::cli {

void Writing::add(const std::string& path, std::function<std::string()> content) {
    (is_stream(path) ? streams_ : files_).push_back({path, std::move(content)});
}

void Writing::write() const {
    Interruption::finish_files_first();
    for (const File& file : files_) files::write_whole(file.path, file.content());
    Interruption::exit_at_once();
    for (const File& stream : streams_) files::write_whole(stream.path, stream.content());
}

}  // namespace lacuna::cli
