/* SPDX-License-Identifier: MIT */
/* In the place of libFuzzer: feeds the files that are named to a target, one after the other. */
#include "fuzz.h"

int main(int argc, char **argv) {
    for (int k = 1; k < argc; k++) {
        FILE *file = fopen(argv[k], "rb");
        char *data = NULL;
        size_t room = 0, size = 0;
        if (!file) return perror(argv[k]), 1;
        do {
            room += 1 << 16;
            data = realloc(data, room);
            if (!data) abort();
            size += fread(data + size, 1, room - size, file);
        } while (size == room);
        fclose(file);
        LLVMFuzzerTestOneInput((const uint8_t *)data, size);
        free(data);
    }
    return 0;
}
