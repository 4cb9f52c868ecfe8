/* A library without the function of a device. */
int nothing(void);
int nothing(void) { return 0; }
