#include "ui/shell/window.h"

#  include  "window.h"
#include "window.moc"
// #include "commented.h" is not an include
