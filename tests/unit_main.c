/* unit_main.c - the main of a program that has none. */
#include "unit.h"

int main(int argc, char **argv) { return unit_main(argc, argv); }
