"""The coast of the Gulf of Mexico as about a hundred named places.

Each place is (name, longitude_deg, latitude_deg, shelf_km) in WGS84, from
general geographic knowledge, good to a few kilometres; between two places the
coast is a straight line. shelf_km is how far off that place the sea stays
shallow, which is where a made ocean must be slow. Not for navigation.

A coast also states its side of the Loop Current: the stream function is one
constant on all land left of the current (the mainland) and another on all land
right of it (Cuba, the Bahamas), so that no water flows through a coast.
"""

from typing import NamedTuple


class Place(NamedTuple):
    name: str
    lon_deg: float
    lat_deg: float
    shelf_km: float


class Coast(NamedTuple):
    name: str
    right_of_current: bool
    half_width_deg: float  # 0: a closed outline; else a chain of islets.
    places: tuple


def _coast(name, right_of_current, rows, half_width_deg=0.0):
    return Coast(name, right_of_current, half_width_deg,
                 tuple(Place(*row) for row in rows))


MAINLAND = _coast("mainland", False, [
    # The Atlantic side, from the Carolinas south.
    ("Murrells Inlet", -79.03, 33.55, 80),
    ("Georgetown", -79.18, 33.19, 85),
    ("Cape Romain", -79.37, 33.00, 90),
    ("Charleston", -79.87, 32.75, 100),
    ("Edisto Island", -80.33, 32.48, 110),
    ("Hilton Head", -80.72, 32.13, 120),
    ("Savannah", -80.84, 32.00, 120),
    ("Sapelo Island", -81.20, 31.40, 120),
    ("Brunswick", -81.40, 31.13, 120),
    ("Fernandina", -81.43, 30.68, 110),
    ("Jacksonville", -81.39, 30.29, 100),
    ("Saint Augustine", -81.29, 29.89, 85),
    ("Daytona Beach", -81.01, 29.21, 60),
    ("Cape Canaveral", -80.53, 28.46, 40),
    ("Melbourne", -80.56, 28.07, 35),
    ("Vero Beach", -80.36, 27.65, 25),
    ("Fort Pierce", -80.28, 27.46, 20),
    ("Jupiter Inlet", -80.07, 26.94, 10),
    ("Palm Beach", -80.03, 26.70, 8),
    ("Fort Lauderdale", -80.10, 26.12, 8),
    ("Miami Beach", -80.13, 25.79, 8),
    ("Key Biscayne", -80.16, 25.67, 8),
    ("Turkey Point", -80.33, 25.43, 10),
    ("Manatee Bay", -80.43, 25.23, 10),
    # The Gulf side of Florida.
    ("Flamingo", -80.92, 25.14, 40),
    ("Cape Sable", -81.12, 25.13, 100),
    ("Ten Thousand Islands", -81.42, 25.82, 170),
    ("Naples", -81.81, 26.14, 190),
    ("Sanibel Island", -82.12, 26.43, 190),
    ("Boca Grande", -82.26, 26.72, 190),
    ("Venice", -82.46, 27.10, 190),
    ("Sarasota", -82.58, 27.33, 190),
    ("Anna Maria", -82.74, 27.52, 190),
    ("Tampa", -82.44, 27.92, 190),
    ("Saint Petersburg", -82.73, 27.68, 190),
    ("Clearwater", -82.83, 27.98, 190),
    ("Tarpon Springs", -82.81, 28.16, 190),
    ("Crystal River", -82.72, 28.90, 190),
    ("Cedar Key", -83.04, 29.13, 190),
    ("Horseshoe Beach", -83.30, 29.43, 180),
    ("Steinhatchee", -83.41, 29.67, 180),
    ("Keaton Beach", -83.60, 29.82, 170),
    ("Saint Marks", -84.18, 30.07, 150),
    ("Alligator Point", -84.38, 29.90, 130),
    ("Carrabelle", -84.67, 29.82, 110),
    ("Apalachicola", -85.03, 29.62, 80),
    ("Cape San Blas", -85.36, 29.67, 60),
    ("Mexico Beach", -85.42, 29.94, 60),
    ("Panama City", -85.74, 30.12, 60),
    ("Destin", -86.50, 30.38, 55),
    ("Pensacola", -87.27, 30.32, 60),
    ("Gulf Shores", -87.70, 30.24, 80),
    ("Fort Morgan", -87.98, 30.23, 90),
    ("Fairhope", -87.91, 30.52, 90),
    ("Mobile", -88.02, 30.68, 90),
    ("Cedar Point", -88.13, 30.32, 90),
    ("Pascagoula", -88.55, 30.34, 100),
    ("Biloxi", -88.89, 30.39, 110),
    ("Bay Saint Louis", -89.33, 30.30, 110),
    ("Pearl River", -89.55, 30.18, 110),
    # Louisiana: the bird's foot of the Mississippi and the bayous.
    ("Saint Bernard", -89.28, 29.97, 80),
    ("Breton Sound", -89.58, 29.62, 50),
    ("Fort Saint Philip", -89.30, 29.36, 30),
    ("Pass a Loutre", -89.02, 29.20, 20),
    ("South Pass", -89.14, 28.99, 20),
    ("Southwest Pass", -89.43, 28.91, 20),
    ("Venice Louisiana", -89.40, 29.20, 40),
    ("Empire", -89.62, 29.28, 50),
    ("Grand Isle", -89.99, 29.24, 70),
    ("Port Fourchon", -90.20, 29.10, 90),
    ("Isles Dernieres", -90.80, 29.04, 110),
    ("Point au Fer", -91.33, 29.29, 140),
    ("Atchafalaya", -91.45, 29.48, 150),
    ("Marsh Island", -91.85, 29.50, 160),
    ("Freshwater Bayou", -92.30, 29.54, 170),
    ("Grand Chenier", -92.90, 29.70, 180),
    ("Cameron", -93.34, 29.77, 190),
    ("Sabine Pass", -93.85, 29.68, 190),
    # Texas.
    ("High Island", -94.40, 29.55, 185),
    ("Bolivar", -94.72, 29.39, 180),
    ("Trinity Bay", -94.75, 29.72, 180),
    ("Kemah", -95.00, 29.55, 180),
    ("Galveston", -94.82, 29.29, 175),
    ("Freeport", -95.30, 28.94, 150),
    ("Matagorda", -95.97, 28.60, 120),
    ("Port O'Connor", -96.40, 28.40, 105),
    ("Port Aransas", -97.05, 27.83, 90),
    ("Corpus Christi", -97.21, 27.60, 85),
    ("Padre Island", -97.38, 27.00, 75),
    ("Port Mansfield", -97.27, 26.56, 70),
    ("Brownsville", -97.16, 26.00, 65),
    # Mexico.
    ("Laguna Madre", -97.42, 25.30, 65),
    ("San Fernando", -97.60, 24.80, 60),
    ("Soto la Marina", -97.74, 23.78, 50),
    ("Barra del Tordo", -97.77, 23.05, 45),
    ("Tampico", -97.79, 22.26, 40),
    ("Cabo Rojo", -97.33, 21.55, 40),
    ("Tuxpan", -97.31, 20.96, 35),
    ("Tecolutla", -97.00, 20.48, 25),
    ("Nautla", -96.77, 20.22, 25),
    ("Palma Sola", -96.42, 19.77, 25),
    ("Chachalacas", -96.33, 19.42, 30),
    ("Veracruz", -96.13, 19.20, 35),
    ("Alvarado", -95.76, 18.78, 35),
    ("Roca Partida", -95.18, 18.70, 25),
    ("Montepio", -95.08, 18.63, 25),
    ("Sontecomapan", -94.97, 18.50, 30),
    ("Coatzacoalcos", -94.41, 18.15, 40),
    ("Sanchez Magallanes", -93.86, 18.30, 40),
    ("Dos Bocas", -93.19, 18.43, 45),
    ("Frontera", -92.69, 18.62, 60),
    ("Ciudad del Carmen", -91.85, 18.66, 110),
    ("Isla Aguada", -91.50, 18.79, 140),
    ("Sabancuy", -91.18, 19.00, 160),
    ("Champoton", -90.73, 19.36, 190),
    ("Seybaplaya", -90.69, 19.64, 200),
    ("Campeche", -90.54, 19.85, 200),
    ("Isla Arena", -90.45, 20.70, 210),
    ("Celestun", -90.41, 20.86, 210),
    ("Sisal", -90.04, 21.17, 220),
    ("Progreso", -89.66, 21.29, 230),
    ("Dzilam de Bravo", -88.89, 21.40, 220),
    ("Rio Lagartos", -88.16, 21.61, 180),
    ("El Cuyo", -87.68, 21.52, 150),
    ("Holbox", -87.38, 21.53, 100),
    ("Cabo Catoche", -87.10, 21.60, 40),
    ("Isla Contoy", -86.82, 21.45, 18),
    ("Cancun", -86.75, 21.13, 12),
    ("Puerto Morelos", -86.87, 20.85, 8),
    ("Playa del Carmen", -87.07, 20.62, 8),
    ("Tulum", -87.43, 20.21, 8),
    ("Punta Allen", -87.47, 19.80, 8),
    ("Mahahual", -87.70, 18.71, 8),
    ("Xcalak", -87.83, 18.27, 8),
    ("Ambergris", -87.96, 17.92, 8),
    # Inland corners that close the outline outside the ocean's box.
    ("Belize inland", -88.20, 17.00, 8),
    ("Chiapas inland", -99.50, 17.00, 40),
    ("Texas inland", -99.50, 34.50, 100),
    ("Carolina inland", -78.60, 34.50, 80),
])

CUBA = _coast("Cuba", True, [
    ("Cabo San Antonio", -84.95, 21.86, 10),
    ("Guadiana Bay", -84.35, 22.12, 12),
    ("Arroyos de Mantua", -84.38, 22.37, 25),
    ("Puerto Esperanza", -83.73, 22.76, 15),
    ("Bahia Honda", -83.17, 22.97, 8),
    ("Mariel", -82.76, 23.02, 6),
    ("Havana", -82.36, 23.15, 6),
    ("Santa Cruz del Norte", -81.92, 23.16, 6),
    ("Matanzas", -81.55, 23.08, 6),
    ("Varadero", -81.15, 23.20, 8),
    ("Cardenas", -81.15, 23.04, 15),
    ("Isabela de Sagua", -80.02, 22.95, 25),
    ("Caibarien", -79.47, 22.53, 30),
    ("Cayo Santa Maria", -79.00, 22.64, 12),
    ("Cayo Coco", -78.40, 22.54, 12),
    ("Cayo Romano", -77.80, 22.20, 12),
    ("Nuevitas", -77.10, 21.60, 8),
    ("Puerto Padre", -76.54, 21.27, 8),
    ("Cabo Lucrecia", -75.62, 21.07, 8),
    ("Baracoa", -74.50, 20.36, 8),
    ("Punta Maisi", -74.13, 20.25, 8),
    ("Guantanamo", -75.15, 19.90, 6),
    ("Santiago", -75.87, 19.97, 6),
    ("Pico Turquino", -76.83, 19.93, 6),
    ("Cabo Cruz", -77.73, 19.84, 6),
    ("Manzanillo", -77.13, 20.35, 40),
    ("Santa Cruz del Sur", -77.98, 20.70, 60),
    ("Jucaro", -78.85, 21.60, 80),
    ("Trinidad", -79.98, 21.74, 20),
    ("Cienfuegos", -80.45, 22.05, 8),
    ("Playa Giron", -81.04, 22.06, 10),
    ("Zapata", -82.10, 22.25, 60),
    ("Batabano", -82.30, 22.68, 60),
    ("La Coloma", -83.57, 22.23, 60),
    ("Punta Cortes", -83.97, 22.07, 40),
    ("Cabo Frances", -84.05, 21.90, 15),
    ("Maria la Gorda", -84.50, 21.84, 6),
    ("Cabo Corrientes", -84.52, 21.76, 6),
])

ISLANDS = (
    _coast("Florida Keys", False, [
        ("Key Largo", -80.38, 25.20, 10),
        ("Islamorada", -80.62, 24.93, 10),
        ("Marathon", -81.09, 24.72, 12),
        ("Big Pine Key", -81.36, 24.68, 12),
        ("Key West", -81.80, 24.56, 12),
    ], half_width_deg=0.035),
    _coast("Cozumel", False, [
        ("Punta Molas", -86.78, 20.53, 6),
        ("Punta Celarain", -86.97, 20.31, 6),
    ], half_width_deg=0.06),
    _coast("Isla de la Juventud", True, [
        ("Nueva Gerona", -82.80, 21.93, 60),
        ("Punta Colombo", -82.57, 21.78, 60),
        ("Punta del Este", -82.55, 21.56, 15),
        ("Punta Cocodrilos", -82.88, 21.44, 6),
        ("Punta Frances", -83.18, 21.60, 10),
        ("Siguanea", -82.96, 21.70, 40),
    ]),
    _coast("Andros", True, [
        ("Morgan's Bluff", -78.03, 25.18, 10),
        ("Fresh Creek", -77.78, 24.72, 8),
        ("South Andros", -77.55, 23.80, 15),
        ("Wide Opening", -77.95, 23.90, 60),
        ("Red Bays", -78.25, 25.00, 90),
    ]),
    _coast("Grand Bahama", True, [
        ("West End", -78.99, 26.69, 15),
        ("Freeport", -78.70, 26.51, 8),
        ("High Rock", -78.28, 26.60, 8),
        ("McLean's Town", -77.92, 26.62, 15),
        ("Dover Sound", -78.40, 26.72, 40),
    ]),
    _coast("Abaco", True, [
        ("Little Abaco", -77.60, 26.90, 30),
        ("Marsh Harbour", -77.05, 26.55, 10),
        ("Hole in the Wall", -77.18, 25.86, 8),
        ("Sandy Point", -77.40, 26.02, 20),
        ("Norman's Castle", -77.40, 26.70, 40),
    ]),
    _coast("Bimini", True, [
        ("North Bimini", -79.27, 25.78, 5),
        ("South Bimini", -79.29, 25.68, 5),
    ], half_width_deg=0.03),
    _coast("New Providence", True, [
        ("Nassau", -77.33, 25.06, 8),
        ("Lyford Cay", -77.53, 25.02, 8),
    ], half_width_deg=0.05),
    _coast("Grand Cayman", True, [
        ("George Town", -81.37, 19.30, 4),
        ("East End", -81.12, 19.32, 4),
    ], half_width_deg=0.04),
    _coast("Jamaica", True, [
        ("Negril", -78.37, 18.27, 10),
        ("Montego Bay", -77.92, 18.50, 6),
        ("Ocho Rios", -77.10, 18.41, 6),
        ("Port Antonio", -76.45, 18.18, 6),
        ("Morant Point", -76.18, 17.92, 8),
        ("Portland Bight", -77.15, 17.72, 20),
        ("Black River", -77.85, 18.02, 20),
    ]),
)

COASTS = (MAINLAND, CUBA) + ISLANDS
