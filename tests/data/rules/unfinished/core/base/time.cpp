// TODO: later
int fixmeNot = 0;  // TODOS and XXXXXX are words of their own
int value = 1;     // FIXME
