// Keeps what an observer calls from asking that observer in turn.
#pragma once

namespace lacuna {

class CancelScope;

// While it lives, the thread's scopes are not asked: an observer may call functions of Lacuna, too.
class Unasked {
public:
    Unasked();
    Unasked(const Unasked&) = delete;
    Unasked& operator=(const Unasked&) = delete;
    ~Unasked();

private:
    const CancelScope* youngest_;
};

}  // namespace lacuna
