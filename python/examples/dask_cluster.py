"""Solves a fan at many speeds on the workers of a Dask cluster; with dask-jobqueue the workers are jobs of Slurm, PBS or LSF."""

import dalembert
import numpy as np
from dask.distributed import Client, LocalCluster

FAN = "vibration/rotating-unbalance"


def amplitude(speed: float) -> float:
    """Amplitude in mm at a speed in rad/s."""
    return float(dalembert.solve(FAN, case=1, speed=speed).amplitude)


def block(speeds: np.ndarray) -> np.ndarray:
    """The same of many speeds at once, by the plain reading; one thread, since the workers share the processors."""
    return dalembert.sweep(FAN, {"speed": speeds}, answers=["amplitude"], case=1, threads=1)["amplitude"]


def main() -> None:
    speeds = np.linspace(60, 160, 400)
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        one_by_one = client.gather(client.map(amplitude, speeds.tolist()))
        in_blocks = np.concatenate(client.gather(client.map(block, np.array_split(speeds, 8))))
    assert np.array_equal(one_by_one, in_blocks)
    at = int(np.argmax(in_blocks))
    print(f"largest amplitude {in_blocks[at]:.2f} mm at {speeds[at]:.1f} rad/s, of {len(speeds)} speeds")


if __name__ == "__main__":
    main()
