// Lets work that knows no observer ask one.
#pragma once

#include <lacuna/cancel.h>
#include <lacuna/lacuna.h>

#include "base/unasked.h"

namespace lacuna {

// Passes everything on to an observer. Meanwhile ask() (base/polling.h) asks that observer too,
// with the progress that was reported last.
class Asked : public Observer {
public:
    Asked(Observer& observer, const Progress& first)
        : observer_(observer),
          last_(first),
          scope_([this] { return observer_.keep_going(last_); }) {}

    bool keep_going(const Progress& progress) override {
        last_ = progress;
        {
            const Unasked unasked;
            if (!observer_.keep_going(progress)) return false;
        }
        scope_.ask_older();
        return true;
    }
    void begin(Verb verb) override { observer_.begin(verb); }
    void end(Verb verb) override { observer_.end(verb); }
    bool times_verbs() const override { return observer_.times_verbs(); }

private:
    Observer& observer_;
    Progress last_;
    CancelScope scope_;
};

}  // namespace lacuna
