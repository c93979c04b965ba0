# Pliant with all that its commands need: docker build -t pliant .
#   docker run --rm --user "$(id -u):$(id -g)" -v "$PWD:/data" pliant sample protein.pdb -o ensemble.h5md
FROM debian:12 AS build
SHELL ["/bin/bash", "-o", "pipefail", "-c"]
# hadolint ignore=DL3008
RUN apt-get update && apt-get install -y --no-install-recommends \
      ca-certificates g++ cmake ninja-build gemmi-dev libbz2-dev libcli11-dev libeigen3-dev \
      libfmt-dev libhdf5-dev liblzma-dev libpugixml-dev nlohmann-json3-dev npm tao-pegtl-dev \
      zlib1g-dev python3 python3-dev python3-venv \
    && rm -rf /var/lib/apt/lists/*
COPY . /source
# The sources as published have the page of pliant play inside, a clone has not.
RUN cd /source && { [ -f python/prebuilt/pliant.html ] || ./dev play; }
RUN python3 -m venv /opt/pliant && /opt/pliant/bin/pip install --no-cache-dir "/source[all]"

FROM debian:12-slim
# hadolint ignore=DL3008
RUN apt-get update && apt-get install -y --no-install-recommends \
      libbz2-1.0 libfmt9 libhdf5-103-1 liblzma5 libpugixml1v5 python3 zlib1g \
    && rm -rf /var/lib/apt/lists/*
COPY --from=build /opt/pliant /opt/pliant
ENV PATH=/opt/pliant/bin:$PATH
RUN useradd --create-home --uid 1000 pliant && mkdir /data && chown pliant /data
USER 1000
WORKDIR /data
ENTRYPOINT ["pliant"]
CMD ["--help"]
