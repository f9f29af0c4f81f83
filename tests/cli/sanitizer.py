# SPDX-License-Identifier: MIT
# Whether a program was built with AddressSanitizer, which reserves terabytes for its own use, so that no limit of memory can be set.


def is_under_address_sanitizer(program):
    with open(program, "rb") as file:
        return b"__asan_init" in file.read()
