/* operations_baseline.c - the operations of packets of two, for every processor. */
#include "../base/arithmetic.h"
#include "operations.h"

#include "baseline.h"
#include "operations_template.h"
