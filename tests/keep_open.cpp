// In builds with sanitizers: libraries stay open. A leak report names a library only while it is there, and takes what
// a library's globals still hold for lost once it is not; Mesa closes its drivers with their context.
extern "C" __attribute__((visibility("default"))) int dlclose(void*) { return 0; }
