# cmake --install: written with the install test (tests/install).
