// One thread: the loops that src/ divides among several.
#pragma once
namespace tbb {

template <class Index, class Body>
void parallel_for(Index first, Index last, const Body& body) {
    for (; first < last; ++first) body(first);
}

}  // namespace tbb
