# The program exsect in an image of its own, on Debian 12: docker build -t exsect . (docs/requirements.md).
FROM debian:12-slim AS build
WORKDIR /exsect
COPY . .
RUN ./setup.sh run
RUN cmake --build --preset release --target exsect_manual_files
RUN cmake --install build/release --component Program --prefix /opt/exsect --strip

FROM debian:12-slim
RUN apt-get update \
 && apt-get install -y --no-install-recommends libflint17 libflint-arb2 libfmt9 libgmp10 libstdc++6 \
 && rm -rf /var/lib/apt/lists/* \
 && useradd --system --no-create-home --shell /usr/sbin/nologin exsect
COPY --from=build /opt/exsect /usr/local
USER exsect
WORKDIR /tmp
ENTRYPOINT ["exsect"]
CMD ["--help"]
