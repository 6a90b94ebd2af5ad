// Included before every file of src/: what the C++ library for wasm32 lacks.
#pragma once
#include "platform/files.h"
#include "platform/fstream.h"
#include "platform/single_thread.h"
