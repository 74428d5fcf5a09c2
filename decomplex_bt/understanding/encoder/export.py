"""Networks as ONNX files with weights of 8 bits, and back: a quarter of the size, two to three times as fast."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from decomplex_bt.understanding.damage import ModelError

ROUNDED = "_quantized"
"""Behind the name of what has 8 bits."""


def export(
    module: Any, example: Sequence[Any], path: Path, *, inputs: Mapping[str, Mapping[int, str]], outputs: Sequence[str]
) -> None:
    """Writes a torch module to `path`; `inputs`: the name of each argument with its axes that vary in length."""
    import torch
    from onnxruntime.quantization import QuantType, quantize_dynamic

    with tempfile.TemporaryDirectory() as scratch:
        exact = Path(scratch) / "exact.onnx"
        torch.onnx.export(
            module,
            tuple(example),
            str(exact),
            input_names=list(inputs),
            output_names=list(outputs),
            dynamic_axes={name: dict(axes) for name, axes in inputs.items()},
            dynamo=False,
        )
        # unsigned: signed weights overflow on processors without VNNI, which then read otherwise than all others
        quantize_dynamic(str(exact), str(path), weight_type=QuantType.QUInt8, per_channel=True)


def weights_of(path: Path) -> dict[str, np.ndarray]:
    """The parameters of a network that `export` wrote, by their names in its `state_dict`, as near as 8 bits come.

    The exporter keeps all names but those of matrices, which it turns as well: each is found by the bias of its layer,
    which is added to its product. Raises `DataFileError` where the file is no such network.
    """
    import onnx
    from onnx import numpy_helper

    try:
        graph = onnx.load(str(path)).graph
        return _named(graph, {tensor.name: numpy_helper.to_array(tensor) for tensor in graph.initializer})
    except Exception as error:  # the library raises those of its parser, of the disk and of numpy
        raise ModelError(path, f"no network of ours ({type(error).__name__})") from None


def _named(graph: Any, stored: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
    readers = {name: node for node in reversed(graph.node) for name in node.input}
    found = {}
    for name, values in stored.items():
        if name.endswith(ROUNDED):
            kept = name.removesuffix(ROUNDED)
            exact = (values.astype(np.float32) - stored[f"{kept}_zero_point"]) * stored[f"{kept}_scale"]
            if readers[name].op_type == "Gather":
                found[kept] = exact
            else:
                found[_bias(name, readers, stored).removesuffix("bias") + "weight"] = np.ascontiguousarray(exact.T)
        elif name.endswith((".weight", ".bias")):
            found[name] = values
    return found


def _bias(matrix: str, readers: Mapping[str, Any], stored: Mapping[str, np.ndarray]) -> str:
    """The name of what is added to the product with a matrix."""
    node = readers[matrix]
    while node.op_type != "Add":
        node = readers[node.output[0]]
    return next(name for name in node.input if name in stored)
