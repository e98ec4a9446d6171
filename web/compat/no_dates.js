// C++ streams, which a few messages use, bring in code that formats dates. Nothing calls it.
mergeInto(LibraryManager['library'], {
    strftime_l: function () { return 0; },
    strftime_l__sig: 'iiiiii',
    strftime_l__deps: [],
});
