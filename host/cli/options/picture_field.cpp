// Options of a picture, and how it becomes a field.
#include "cli/options/picture_field.h"

#include <algorithm>
#include <utility>

#include "cli/options/options.h"
#include "pictures/image.h"

namespace lacuna::cli {
namespace {

void read_sharpen(const std::string& text, pictures::Importance& importance) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    read("sharpen", text.substr(0, colon), importance.sharpen);
    if (colon != text.size()) read("sharpen", text.substr(colon + 1), importance.sharpen_amount);
}

}  // namespace

Targets targets_of(Picture& picture) {
    pictures::Importance& importance = picture.importance;
    return {{"metric", &picture.metric},
            {"invert", &importance.invert},
            {"black", &importance.black},
            {"white", &importance.white},
            {"auto-levels", &importance.auto_levels},
            {"sharpen", [&importance](const std::string& text) { read_sharpen(text, importance); }},
            {"along", &importance.along},
            {"gamma", &importance.gamma},
            {"min-importance", &importance.min_importance}};
}

Field read_field(const Picture& picture, Request& request) {
    pictures::Image image = pictures::read_image(picture.path, pictures::kLargestAspect);
    const double longer = std::max(image.columns, image.rows);
    request.width = image.columns / longer;
    request.height = image.rows / longer;
    return pictures::importance_of(std::move(image), picture.importance);
}

}  // namespace lacuna::cli
