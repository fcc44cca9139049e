/* SPDX-License-Identifier: MIT */
#include "contract/system.h"
#include "walk.h"

int main(int argc, char **argv)
{
    system_start(argc, argv);
    system_exit(walk());
    return SYSTEM_EXIT_DONE; /* not reached */
}
