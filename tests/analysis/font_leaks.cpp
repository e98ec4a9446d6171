// Tells LeakSanitizer that fontconfig, which finds cairo's fonts, keeps a few values to the end.
extern "C" const char* __lsan_default_suppressions();  // NOLINT: the sanitizer's name for it
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libfontconfig\n";
}  // NOLINT
