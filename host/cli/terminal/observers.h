// Several observers of one run, which are called one after another.
#pragma once

#include <lacuna/lacuna.h>
#include <functional>
#include <utility>
#include <vector>

namespace lacuna::cli {

class Observers : public Observer {
public:
    explicit Observers(std::vector<std::reference_wrapper<Observer>> all) : all_(std::move(all)) {}

    bool keep_going(const Progress& progress) override {
        bool all_agree = true;
        for (Observer& observer : all_) all_agree = observer.keep_going(progress) && all_agree;
        return all_agree;
    }
    void begin(Verb verb) override {
        for (Observer& observer : all_) observer.begin(verb);
    }
    void end(Verb verb) override {
        for (Observer& observer : all_) observer.end(verb);
    }

private:
    std::vector<std::reference_wrapper<Observer>> all_;
};

}  // namespace lacuna::cli
