// A field, and what is claimed of a set that follows it.
#pragma once

#include <lacuna/verify.h>

namespace lacuna::verify {

struct OnField {
    Field field;
    double scale = 1;
    lacuna::Domain domain{};

    Claim claim() const {
        Claim claim;
        claim.domain = domain;
        claim.field = &field;
        claim.scale = scale;
        return claim;
    }
};

}  // namespace lacuna::verify
