// C++'s streams, which a few messages are made with, bring what writes dates; nobody writes one.
mergeInto(LibraryManager['library'], {
    strftime_l: function () { return 0; },
    strftime_l__sig: 'iiiiii',
    strftime_l__deps: [],
});
