// Options of a picture, and how it becomes a field.
#include "cli/options/picture_field.h"

#include <algorithm>
#include <utility>

#include "pictures/image.h"

namespace lacuna::cli {
Targets targets_of(Picture& picture) {
    Targets targets = recipes::targets_of(picture.importance);
    targets["metric"] = &picture.metric;
    return targets;
}

Field read_field(const Picture& picture, Request& request) {
    pictures::Image image = pictures::read_image(picture.path, pictures::kLargestAspect);
    request.domain = domain_like(image.columns, image.rows, request.domain.boundary);
    return pictures::importance_of(std::move(image), picture.importance);
}

}  // namespace lacuna::cli
