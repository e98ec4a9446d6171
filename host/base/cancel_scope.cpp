// The scopes of each thread.
#include <lacuna/cancel.h>

#include <cstddef>
#include <utility>

#include "base/polling.h"
#include "base/unasked.h"

namespace lacuna {
namespace {

thread_local const CancelScope* youngest = nullptr;
thread_local std::size_t work = 0;  // since the thread asked

}  // namespace

CancelScope::CancelScope(std::function<bool()> keep_going)
    : keep_going_(std::move(keep_going)), older_(std::exchange(youngest, this)) {
    work = 0;
}

CancelScope::~CancelScope() {
    youngest = older_;
}

void CancelScope::ask_from(const CancelScope* scope) {
    if (scope == nullptr) return;
    const Unasked unasked;
    for (; scope != nullptr; scope = scope->older_)
        if (!scope->keep_going_()) throw Cancelled();
}

Unasked::Unasked() : youngest_(std::exchange(youngest, nullptr)) {}

Unasked::~Unasked() {
    youngest = youngest_;
}

void CancelScope::ask_older() const {
    ask_from(older_);
}

void ask() {
    CancelScope::ask_from(youngest);
}

void ask_after(std::size_t pixels) {
    if (work += pixels; work < kBetweenPolls) return;
    work = 0;
    ask();
}

}  // namespace lacuna
