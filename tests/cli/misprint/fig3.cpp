// A figure 3 with a number outside its band. This object takes precedence over the library's.
#include "reproduce/reproduce.h"

namespace lacuna::reproduce {

Reproduction fig3(const Setting&) {
    return {{printed("planted", 100, 100.4, 0.5), printed("planted", 100, 100.6, 0.5)},
            {{"planted", true}},
            files::Medium::svg,
            "<?xml?>"};
}

}  // namespace lacuna::reproduce
