"""Reading tables and layouts in little code.

``item(a, i)`` is ``a[i]`` and ``item(a, i, j)`` is ``a[i, j]``, for indices that are not negative. A subscript in Warp
looks up shape and strides and lets negative indices count from the end, which costs several times what the element
does. Here an element lies right behind the one before it in its row, and vectors are read in one piece.
"""

import warp as wp

wp.set_module_options({"enable_backward": False})

ALIGNED = {
    wp.uint8: 1,
    wp.int32: 4,
    wp.uint32: 4,
    wp.float32: 4,
    wp.vec2: 8,
    wp.vec2i: 8,
    wp.vec3: 4,
    wp.vec3i: 4,
    wp.vec4: 16,
    wp.vec4i: 16,
}
READ = """
    auto at = static_cast<decltype(a.data)>(__builtin_assume_aligned({at}, {align}));
#if defined(__CUDA_ARCH__)
    __builtin_assume(__isGlobal(at));
#endif
    return *at;
"""
IN_LINE = "a.data + i"
IN_TABLE = "reinterpret_cast<char*>(a.data + j) + static_cast<long long>(i) * a.strides[0]"
ANYWHERE = "reinterpret_cast<char*>(a.data) + static_cast<long long>(i) * a.strides[0]"
ANYWHERE += " + static_cast<long long>(j) * a.strides[1]"

for _dtype, _align in ALIGNED.items():

    @wp.func_native(READ.format(at=IN_LINE, align=_align))
    def item(a: wp.array(dtype=_dtype), i: wp.int32) -> _dtype:
        """Element i."""
        ...

    @wp.func_native(READ.format(at=IN_TABLE, align=_align))
    def item(a: wp.array2d(dtype=_dtype), i: wp.int32, j: wp.int32) -> _dtype:  # noqa: F811
        """Element j of row i."""
        ...


for _dtype in (wp.int32, wp.vec2, wp.vec4):

    @wp.func_native(READ.format(at=ANYWHERE, align=ALIGNED[_dtype]))
    def item_strided(a: wp.array2d(dtype=_dtype), i: wp.int32, j: wp.int32) -> _dtype:
        """Element j of row i of a layout, whether its rows or its columns lie in one piece."""
        ...


@wp.func_native("""
#if defined(__CUDA_ARCH__)
    int step;
    asm volatile("mov.u32 %0, 1;" : "=r"(step));
    return step;
#else
    return 1;
#endif
""")
def opaque_one() -> wp.int32:
    """1, but no compiler knows: a loop in steps of it is not unrolled and takes little of the instruction cache."""
    ...


@wp.func_native("""
#if defined(__CUDA_ARCH__)
#undef WP_NOINLINE
#define WP_NOINLINE
#endif
""")
def inline_on_gpu():
    """Called first in a kernel: on a GPU, functions with ``inline=False`` are inlined there after all.

    A call makes a GPU spill what lives across it, and hides from it what of the result is not needed. On a CPU such
    functions are better off as calls, and everywhere else they keep the code short.
    """
    ...
